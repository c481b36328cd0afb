#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mirada::session {

/// Whose faces were learnt, without what they look like.
struct KnownFaces {
  struct Person {
    std::string name;
    std::size_t looks = 0;
  };
  bool allowed = false;  ///< a teacher has allowed learning and recognising
  std::vector<Person> people;
  std::uint64_t revision = 0;  ///< grows with every change
};

/// What somebody asks of them.
struct FacesStep {
  enum class Action { allow, rename, forget, forget_all };
  Action action = Action::forget_all;
  bool on = false;       ///< allow
  std::string code;      ///< allow: the teacher's
  std::string name, to;  ///< rename, forget
};

}  // namespace mirada::session
