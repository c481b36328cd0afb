#include "vision/identity/face_book.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "base/messages.h"
#include "vision/messages.h"

namespace mirada::vision {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kLargestBook = 32u << 20;
constexpr std::size_t kLongestFeature = 8192;

Fault unknown_name(const std::string& name) {
  return make_fault("", messages::face_unknown_name, {{"name", name}});
}

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Without control characters and those that break lines or turn the direction of writing: they change what
/// stands beside a name.
std::string printable(const std::string& text) {
  constexpr std::string_view kHidden[] = {"\u061C", "\u200E", "\u200F", "\u2028", "\u2029",
                                          "\u202A", "\u202B", "\u202C", "\u202D", "\u202E",
                                          "\u2066", "\u2067", "\u2068", "\u2069"};
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = std::string_view(text).substr(i);
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(rest[k]); };
    const auto* hidden = std::find_if(std::begin(kHidden), std::end(kHidden),
                                      [&](std::string_view one) { return rest.starts_with(one); });
    if (hidden != std::end(kHidden)) {
      i += hidden->size();
    } else if (byte(0) == 0xC2 && rest.size() > 1 && byte(1) < 0xA0) {
      i += 2;  // a control character, too: U+0080 to U+009F
    } else {
      if (byte(0) >= ' ' && byte(0) != 0x7F) out += rest[0];
      ++i;
    }
  }
  return out;
}

bool is_utf8(const std::string& text) {
  return !json(text).dump(-1, ' ', false, json::error_handler_t::replace).empty() &&
         json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)) == json(text);
}

auto by_name(auto& people, const std::string& name) {
  return std::find_if(people.begin(), people.end(), [&](const auto& one) { return one.name == name; });
}

/// How like somebody: the mean of their two looks that are most like, so that no single odd look decides.
double likeness_to(const std::vector<FaceFeature>& looks, const FaceFeature& feature) {
  double best = -1, next = -1;
  for (const FaceFeature& look : looks) {
    const double here = likeness(look, feature);
    next = std::max(next, std::min(best, here));
    best = std::max(best, here);
  }
  return looks.size() < 2 ? best : (best + next) / 2;
}

}  // namespace

Status check_face_name(const std::string& name) {
  const bool blank = name.find_first_not_of(" \t\r\n") == std::string::npos;
  if (!blank && characters(name) <= FaceBook::kLongestName && is_utf8(name) && printable(name) == name)
    return Ok{};
  return make_fault("", messages::face_name_bad, {{"max", std::to_string(FaceBook::kLongestName)}});
}

Result<std::shared_ptr<FaceBook>> FaceBook::open(const std::filesystem::path& file) {
  std::shared_ptr<FaceBook> book(new FaceBook(file));
  if (const Status done = book->take_over(); !done) return done.faults();
  return book;
}

/// What the file holds now: nobody when it is gone. A fault, and nothing is different, when it cannot be
/// read.
Status FaceBook::take_over() {
  std::error_code error;
  const bool there = std::filesystem::exists(file_, error);
  if (error) return make_fault(file_.string(), messages::face_book_broken, {{"file", file_.string()}});
  if (!there) {
    set({}, false);
    return Ok{};
  }
  const auto text = read_file(file_, kLargestBook);
  const Status done = text ? read(*text) : Status(text.faults());
  if (done) return done;
  Faults faults{make_fault(file_.string(), messages::face_book_broken, {{"file", file_.string()}})};
  faults.insert(faults.end(), done.faults().begin(), done.faults().end());
  return faults;
}

void FaceBook::set(std::vector<Known> people, bool allowed) {
  std::sort(people.begin(), people.end(), [](const Known& a, const Known& b) { return a.name < b.name; });
  const std::lock_guard lock(mutex_);
  if (people == people_ && allowed == allowed_) return;
  people_ = std::move(people);
  allowed_ = allowed;
  ++revision_;
}

Result<std::shared_ptr<FaceBook>> FaceBook::copy_of(const std::filesystem::path& file) {
  auto book = open(file);
  if (!book) return book;
  (*book)->file_.clear();
  (*book)->allowed_ = true;
  return book;
}

Status FaceBook::read(const std::string& text) {
  const auto parsed = parse_json(text, file_.string());
  if (!parsed) return parsed.faults();
  Faults faults;
  JsonReader in(*parsed, "", faults);
  in.choice("format", {"mirada-faces"});
  in.number("version", 1, 1);
  bool allowed = in.truth_or("allowed", false);
  std::vector<Known> people;
  for (JsonReader& person : in.objects("people", kMostPeople)) {
    // Names that once were taken load for ever.
    Known known{printable(person.text("name")), person.text("kind"), {}};
    for (JsonReader& look : person.objects("looks", kMostLooks)) {
      const std::vector<double> values = look.numbers("feature", 1, kLongestFeature, -1, 1);
      known.looks.emplace_back(values.begin(), values.end());
    }
    if (const Status fine = check_face_name(known.name); !fine) faults.push_back(fine.faults().front());
    people.push_back(std::move(known));
  }
  if (has_errors(faults)) return faults;
  for (const Edit& edit : owed_) (void)edit(people, allowed);
  set(std::move(people), allowed);
  return Ok{};
}

Status FaceBook::write(const std::vector<Known>& people, bool allowed) const {
  constexpr unsigned kOwnerOnly = 0600;
  json out{{"format", "mirada-faces"}, {"version", 1}, {"allowed", allowed}, {"people", json::array()}};
  for (const Known& person : people) {
    json looks = json::array();
    for (const FaceFeature& look : person.looks) looks.push_back({{"feature", look}});
    out["people"].push_back({{"name", person.name}, {"kind", person.kind}, {"looks", std::move(looks)}});
  }
  return write_file_atomically(file_, out.dump() + "\n", kOwnerOnly);
}

Status FaceBook::change(const Edit& edit, bool ends_lesson) {
  const std::lock_guard changing(change_mutex_);
  return change_now(edit, ends_lesson);
}

/// Written first, believed then; but a no and forgetting everybody hold here even when the file cannot be
/// read or written. A lesson that began while the file was written ends with them, too.
Status FaceBook::change_now(const Edit& edit, bool ends_lesson) {
  std::optional<FileLock> others_wait;
  Status kept = Ok{};
  if (is_kept()) {
    std::error_code error;
    if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path(), error);
    others_wait.emplace(file_);
    kept = take_over();
    if (!kept && !ends_lesson) return kept;
  }
  std::vector<Known> people;
  bool allowed = false;
  {
    const std::lock_guard lock(mutex_);
    people = people_;
    allowed = allowed_;
    if (ends_lesson) lesson_.reset();
  }
  const Result<bool> changed = edit(people, allowed);
  if (!changed) return changed.faults();
  if (!*changed && owed_.empty()) return kept;
  if (is_kept() && kept) kept = write(people, allowed);
  if (!kept && !ends_lesson) return kept;
  if (kept)
    owed_.clear();
  else
    owed_.push_back(edit);
  set(std::move(people), allowed);
  const std::lock_guard lock(mutex_);
  if (ends_lesson) lesson_.reset();
  return kept;
}

bool FaceBook::allowed() const {
  const std::lock_guard lock(mutex_);
  return allowed_;
}

Status FaceBook::allow(bool on) {
  return change(
      [on](std::vector<Known>&, bool& allowed) -> Result<bool> { return std::exchange(allowed, on) != on; },
      !on);
}

std::vector<FaceBook::Person> FaceBook::people() const {
  const std::lock_guard lock(mutex_);
  std::vector<Person> out;
  for (const Known& person : people_) out.push_back({person.name, person.looks.size()});
  return out;
}

Result<bool> FaceBook::add(std::vector<Known>& people, const std::string& name, const std::string& kind,
                           const std::vector<FaceFeature>& looks) {
  if (const Status fine = check_face_name(name); !fine) return fine.faults();
  auto known = by_name(people, name);
  if (known == people.end()) {
    if (people.size() >= kMostPeople)
      return make_fault("", messages::face_book_full, {{"max", std::to_string(kMostPeople)}});
    known = people.insert(people.end(), Known{name, kind, {}});
  }
  // Features of another kind say nothing any more.
  if (known->kind != kind) *known = {name, kind, {}};
  known->looks.insert(known->looks.end(), looks.begin(), looks.end());
  if (known->looks.size() > kMostLooks)
    known->looks.erase(known->looks.begin(), known->looks.end() - static_cast<std::ptrdiff_t>(kMostLooks));
  return true;
}

Status FaceBook::learn(const std::string& name, const std::string& kind,
                       const std::vector<FaceFeature>& looks) {
  return change([&](std::vector<Known>& people, bool&) { return add(people, name, kind, looks); });
}

Status FaceBook::rename(const std::string& name, const std::string& to) {
  if (const Status fine = check_face_name(to); !fine) return fine;
  return change([&](std::vector<Known>& people, bool&) -> Result<bool> {
    const auto known = by_name(people, name);
    if (known == people.end()) return unknown_name(name);
    if (name == to) return false;
    if (by_name(people, to) != people.end()) return make_fault("", messages::face_name_taken, {{"name", to}});
    known->name = to;
    return true;
  });
}

Status FaceBook::forget(const std::string& name) {
  return change([&](std::vector<Known>& people, bool&) -> Result<bool> {
    const auto known = by_name(people, name);
    if (known == people.end()) return unknown_name(name);
    people.erase(known);
    return true;
  });
}

Status FaceBook::forget_all() {
  return change(
      [](std::vector<Known>& people, bool&) -> Result<bool> {
        const bool any = !people.empty();
        people.clear();
        return any;
      },
      true);
}

FaceBook::Match FaceBook::match(const FaceFeature& feature, const std::string& kind) const {
  const std::lock_guard lock(mutex_);
  Match out{"", -1, -1};
  for (const Known& person : people_) {
    if (person.kind != kind || person.looks.empty()) continue;
    const double here = likeness_to(person.looks, feature);
    if (here > out.likeness) {
      out = {person.name, here, out.likeness};
    } else {
      out.next_likeness = std::max(out.next_likeness, here);
    }
  }
  return out;
}

std::uint64_t FaceBook::begin_lesson(const std::string& name) {
  const std::lock_guard lock(mutex_);
  lesson_ = Lesson{++lessons_, name, "", {}, &messages::lesson_show_face};
  return lessons_;
}

std::optional<LessonPercept> FaceBook::lesson() const {
  const std::lock_guard lock(mutex_);
  if (!lesson_) return std::nullopt;
  return LessonPercept{lesson_->name, static_cast<int>(lesson_->looks.size()), kLessonLooks, lesson_->hint};
}

std::uint64_t FaceBook::lesson_number() const {
  const std::lock_guard lock(mutex_);
  return lesson_ ? lesson_->number : 0;
}

std::optional<std::size_t> FaceBook::looks_of(std::uint64_t lesson) const {
  const std::lock_guard lock(mutex_);
  if (!lesson_ || lesson_->number != lesson) return std::nullopt;
  return lesson_->looks.size();
}

std::vector<FaceFeature> FaceBook::lesson_looks() const {
  const std::lock_guard lock(mutex_);
  return lesson_ ? lesson_->looks : std::vector<FaceFeature>();
}

void FaceBook::teach(std::uint64_t lesson, const std::string& kind, std::optional<FaceFeature> look,
                     const Message* hint) {
  const std::lock_guard lock(mutex_);
  if (!lesson_ || lesson_->number != lesson) return;
  lesson_->hint = hint;
  if (!look || lesson_->looks.size() >= static_cast<std::size_t>(kLessonLooks)) return;
  lesson_->kind = kind;
  lesson_->looks.push_back(std::move(*look));
}

Status FaceBook::end_lesson(std::uint64_t lesson, bool keep) {
  std::unique_lock changing(change_mutex_, std::defer_lock);
  // Before the lesson is taken out: whoever forgets everybody meanwhile finds it in one place or the other.
  if (keep) changing.lock();
  Lesson done;
  {
    const std::lock_guard lock(mutex_);
    if (!lesson_ || lesson_->number != lesson) return Ok{};
    done = std::move(*lesson_);
    lesson_.reset();
  }
  if (!keep) return Ok{};
  return change_now(
      [&](std::vector<Known>& people, bool& allowed) -> Result<bool> {
        if (!allowed) return false;
        return add(people, done.name, done.kind, done.looks);
      },
      false);
}

std::future<Status> FaceBook::keep_lesson(std::uint64_t lesson) {
  const auto task = std::make_shared<std::packaged_task<Status()>>([this, lesson] {
    try {
      return end_lesson(lesson, true);
    } catch (const std::exception& error) {  // no memory, say: nothing is kept, and the robot goes on
      return Status(make_fault(file_.string(), messages::file_not_written,
                               {{"file", file_.string()}, {"reason", error.what()}}));
    }
  });
  std::future<Status> answer = task->get_future();
  if (!is_kept()) {
    (*task)();
    return answer;
  }
  const std::lock_guard lock(writing_mutex_);
  beside([task] { (*task)(); });
  return answer;
}

void FaceBook::notice_changes() {
  if (!is_kept()) return;
  const std::lock_guard lock(writing_mutex_);
  const std::string now = file_mark(file_);
  if (now == std::exchange(noticed_, now)) return;
  beside([this] {
    const std::lock_guard changing(change_mutex_);
    // A spoilt file is said when somebody wants to change it.
    (void)take_over();
  });
}

void FaceBook::beside(std::function<void()> work) {
  writing_.remove_if(
      [](const auto& one) { return one.wait_for(std::chrono::seconds(0)) == std::future_status::ready; });
  try {
    writing_.push_back(std::async(std::launch::async, work));
  } catch (const std::system_error&) {  // no thread to be had: better late than never
    work();
  }
}

}  // namespace mirada::vision
