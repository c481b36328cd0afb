#pragma once
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "model/percepts.h"
#include "vision/identity/face_describer.h"

namespace mirada::vision {

/// The people whose faces were learnt: a name and features each, never pictures; and whether anybody may be
/// learnt or recognised at all, which a teacher decides (off at first). Kept in one file, written atomically,
/// or in memory only. Other programs may change the same file: what they did is taken over with the next
/// change made here, or by notice_changes(). Every call may come from any thread; what changes people or
/// allowed() waits for the file, everything else never does.
class FaceBook {
 public:
  static constexpr std::size_t kMostPeople = 60;
  static constexpr std::size_t kMostLooks = 12;  ///< of one person; the oldest give way
  static constexpr std::size_t kLongestName = 40;

  /// In memory only.
  FaceBook() = default;
  /// Kept in this file, which need not exist yet. A file that cannot be read is a fault and stays as it is.
  static Result<std::shared_ptr<FaceBook>> open(const std::filesystem::path& file);

  /// What this file holds, allowed and in memory only: changes are not written. No file: nobody.
  static Result<std::shared_ptr<FaceBook>> copy_of(const std::filesystem::path& file);

  bool allowed() const;
  Status allow(bool on);

  struct Person {
    std::string name;
    std::size_t looks = 0;
  };
  std::vector<Person> people() const;  ///< by name
  /// Takes over, beside the caller, what other programs have done to the file since; costs one look at its
  /// date.
  void notice_changes();
  /// Grows when people or allowed() are different.
  std::uint64_t revision() const { return revision_; }

  Status learn(const std::string& name, const std::string& kind, const std::vector<FaceFeature>& looks);
  Status rename(const std::string& name, const std::string& to);
  Status forget(const std::string& name);
  Status forget_all();

  /// Who a feature is most like, of those with features of this kind; "" when there is nobody.
  struct Match {
    std::string name;
    double likeness = 0;
    double next_likeness = 0;  ///< of the second
  };
  Match match(const FaceFeature& feature, const std::string& kind) const;

  // A lesson: one at a time; a new one takes the place of the old.

  /// Begins to learn this name; its number.
  std::uint64_t begin_lesson(const std::string& name);
  /// How it goes, or nothing when none goes on.
  std::optional<LessonPercept> lesson() const;
  std::uint64_t lesson_number() const;
  /// Looks of this lesson so far; nothing when it is over.
  std::optional<std::size_t> looks_of(std::uint64_t lesson) const;
  /// One more look, or only what to do.
  void teach(std::uint64_t lesson, const std::string& kind, std::optional<FaceFeature> look,
             const Message* hint);
  /// The looks of the lesson so far.
  std::vector<FaceFeature> lesson_looks() const;
  /// Ends it: its looks are learnt, or dropped. Nothing happens when it is over already.
  Status end_lesson(std::uint64_t lesson, bool keep);
  /// end_lesson(lesson, true), without waiting for a file; the book is not destroyed before that is written.
  std::future<Status> keep_lesson(std::uint64_t lesson);

  static constexpr int kLessonLooks = 8;
  static constexpr int kFewestLooks = 3;  ///< a shorter lesson is none

 private:
  struct Known {
    std::string name;
    std::string kind;
    std::vector<FaceFeature> looks;
    bool operator==(const Known&) const = default;
  };
  struct Lesson {
    std::uint64_t number = 0;
    std::string name;
    std::string kind;
    std::vector<FaceFeature> looks;
    const Message* hint = nullptr;
  };

  explicit FaceBook(std::filesystem::path file) : file_(std::move(file)) {}
  bool is_kept() const { return !file_.empty(); }
  Status take_over();
  Status read(const std::string& text);
  void set(std::vector<Known> people, bool allowed);
  /// Whether anything is different then.
  using Edit = std::function<Result<bool>(std::vector<Known>& people, bool& allowed)>;
  Status change(const Edit& edit, bool ends_lesson = false);
  Status change_now(const Edit& edit, bool ends_lesson);  ///< with change_mutex_ held
  Status write(const std::vector<Known>& people, bool allowed) const;
  static Result<bool> add(std::vector<Known>& people, const std::string& name, const std::string& kind,
                          const std::vector<FaceFeature>& looks);

  std::filesystem::path file_;  ///< "" = in memory only; never changes once the book is open
  std::mutex change_mutex_;     ///< one change at a time, its file included; taken before mutex_
  std::vector<Edit>
      owed_;  ///< a no, forgetting everybody: hold here, but could not be written; with change_mutex_
  mutable std::mutex mutex_;   ///< of everything below but the revision; never held while a file is written
  std::vector<Known> people_;  ///< by name
  bool allowed_ = false;
  std::atomic<std::uint64_t> revision_ = 1;
  std::optional<Lesson> lesson_;
  std::uint64_t lessons_ = 0;
  void beside(std::function<void()> work);  ///< with writing_mutex_ held

  std::mutex writing_mutex_;                ///< of what follows
  std::optional<std::string> noticed_;      ///< the file's mark
  std::list<std::future<void>> writing_{};  ///< waited for first of all when the book is destroyed
};

/// Whether this may be somebody's name: 1 to 40 characters of text.
Status check_face_name(const std::string& name);

}  // namespace mirada::vision
