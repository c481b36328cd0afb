#pragma once
#include <cassert>
#include <utility>
#include <variant>

#include "base/fault.h"

namespace mirada {

/// A value, or every fault that kept it from being made (at least one). For what people send and what the
/// world does; our own bugs are assertions.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Faults faults) : content_(std::in_place_index<1>, std::move(faults)) {}
  Result(Fault fault) : content_(std::in_place_index<1>, Faults{std::move(fault)}) {}

  bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & {
    assert(ok());
    return *std::get_if<0>(&content_);
  }
  const T& value() const& {
    assert(ok());
    return *std::get_if<0>(&content_);
  }
  T&& value() && {
    assert(ok());
    return std::move(*std::get_if<0>(&content_));
  }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }

  const Faults& faults() const {
    assert(!ok());
    return *std::get_if<1>(&content_);
  }

 private:
  std::variant<T, Faults> content_;
};

/// Success without a value.
struct Ok {};
using Status = Result<Ok>;

}  // namespace mirada
