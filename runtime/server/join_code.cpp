#include "server/join_code.h"

#include <random>

namespace mirada::server {
namespace {

constexpr std::string_view kAlphabet = "23456789ABCDEFGHJKLMNPQRSTUVWXYZ";  // without 0 O 1 I
static_assert(kAlphabet.size() == 32);
constexpr std::size_t kLength = 6;

std::string plain(std::string_view typed) {
  std::string out;
  for (const char c : typed.substr(0, 64)) {
    if (c == ' ' || c == '-') continue;
    out += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return out;
}

}  // namespace

std::string make_join_code() {
  std::random_device source;
  std::string code;
  for (std::size_t i = 0; i < kLength; ++i) code += kAlphabet[source() % kAlphabet.size()];
  return code;
}

bool same_code(std::string_view typed, std::string_view code) {
  const std::string given = plain(typed);
  // Volatile keeps the compiler from leaving the loop early.
  volatile unsigned difference = given.size() == code.size() ? 0u : 1u;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = i < given.size() ? given[i] : '\0';
    difference = difference | static_cast<unsigned>(static_cast<unsigned char>(c ^ code[i]));
  }
  return difference == 0 && !code.empty();
}

bool TryLimit::allows(Micros now) {
  while (!tries_.empty() && now - tries_.front() >= window_) tries_.pop_front();
  return tries_.size() < most_;
}

}  // namespace mirada::server
