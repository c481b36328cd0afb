#include "vision/identity/face_book.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
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
  if (!blank && characters(name) <= FaceBook::kLongestName && is_utf8(name)) return Ok{};
  return make_fault("", messages::face_name_bad, {{"max", std::to_string(FaceBook::kLongestName)}});
}

Result<std::shared_ptr<FaceBook>> FaceBook::open(const std::filesystem::path& file) {
  std::shared_ptr<FaceBook> book(new FaceBook(file));
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return book;
  const auto text = read_file(file, kLargestBook);
  const Status done = text ? book->read(*text) : Status(text.faults());
  if (done) return book;
  return make_fault(file.string(), messages::face_book_broken,
                    {{"file", file.string()}, {"reason", done.faults().front().text(Lang::en)}});
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
  allowed_ = in.truth_or("allowed", false);
  for (JsonReader& person : in.objects("people", kMostPeople)) {
    Known known{person.text("name"), person.text("kind"), {}};
    for (JsonReader& look : person.objects("looks", kMostLooks)) {
      const std::vector<double> values = look.numbers("feature", 1, kLongestFeature, -1, 1);
      known.looks.emplace_back(values.begin(), values.end());
    }
    people_.push_back(std::move(known));
  }
  if (has_errors(faults)) return faults;
  std::sort(people_.begin(), people_.end(), [](const Known& a, const Known& b) { return a.name < b.name; });
  return Ok{};
}

/// Written first, believed then. With the mutex held.
Status FaceBook::save(std::vector<Known> people, bool allowed) {
  std::sort(people.begin(), people.end(), [](const Known& a, const Known& b) { return a.name < b.name; });
  if (!file_.empty()) {
    json out{{"format", "mirada-faces"}, {"version", 1}, {"allowed", allowed}, {"people", json::array()}};
    for (const Known& person : people) {
      json looks = json::array();
      for (const FaceFeature& look : person.looks) looks.push_back({{"feature", look}});
      out["people"].push_back({{"name", person.name}, {"kind", person.kind}, {"looks", std::move(looks)}});
    }
    std::error_code error;
    if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path(), error);
    const Status written = write_file_atomically(file_, out.dump() + "\n");
    if (!written) return written;
    std::filesystem::permissions(
        file_, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write, error);
  }
  people_ = std::move(people);
  allowed_ = allowed;
  ++revision_;
  return Ok{};
}

bool FaceBook::allowed() const {
  const std::lock_guard lock(mutex_);
  return allowed_;
}

Status FaceBook::allow(bool on) {
  const std::lock_guard lock(mutex_);
  if (!on) lesson_.reset();
  return on == allowed_ ? Status(Ok{}) : save(people_, on);
}

std::vector<FaceBook::Person> FaceBook::people() const {
  const std::lock_guard lock(mutex_);
  std::vector<Person> out;
  for (const Known& person : people_) out.push_back({person.name, person.looks.size()});
  return out;
}

std::uint64_t FaceBook::revision() const {
  const std::lock_guard lock(mutex_);
  return revision_;
}

Status FaceBook::add(const std::string& name, const std::string& kind,
                     const std::vector<FaceFeature>& looks) {
  if (const Status fine = check_face_name(name); !fine) return fine;
  std::vector<Known> people = people_;
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
  return save(std::move(people), allowed_);
}

Status FaceBook::learn(const std::string& name, const std::string& kind,
                       const std::vector<FaceFeature>& looks) {
  const std::lock_guard lock(mutex_);
  return add(name, kind, looks);
}

Status FaceBook::rename(const std::string& name, const std::string& to) {
  const std::lock_guard lock(mutex_);
  if (const Status fine = check_face_name(to); !fine) return fine;
  std::vector<Known> people = people_;
  const auto known = by_name(people, name);
  if (known == people.end()) return unknown_name(name);
  if (name == to) return Ok{};
  if (by_name(people, to) != people.end()) return make_fault("", messages::face_name_taken, {{"name", to}});
  known->name = to;
  return save(std::move(people), allowed_);
}

Status FaceBook::forget(const std::string& name) {
  const std::lock_guard lock(mutex_);
  std::vector<Known> people = people_;
  const auto known = by_name(people, name);
  if (known == people.end()) return unknown_name(name);
  people.erase(known);
  return save(std::move(people), allowed_);
}

Status FaceBook::forget_all() {
  const std::lock_guard lock(mutex_);
  lesson_.reset();
  return save({}, allowed_);
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
  const std::lock_guard lock(mutex_);
  if (!lesson_ || lesson_->number != lesson) return Ok{};
  const Lesson done = std::move(*lesson_);
  lesson_.reset();
  return keep && allowed_ ? add(done.name, done.kind, done.looks) : Status(Ok{});
}

}  // namespace mirada::vision
