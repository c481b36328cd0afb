#include "vm/code.h"

namespace mirada::vm {
namespace {

constexpr OpRow kRows[] = {
#define KIND(letter) (#letter)[0]
#define OP(name, a, b, c, meaning) {#name, KIND(a), KIND(b), KIND(c), false, meaning},
#define HOT(name, a, b, c, meaning) {#name, KIND(a), KIND(b), KIND(c), true, meaning},
#include "vm/opcodes.def"
#undef HOT
#undef OP
#undef KIND
};

}  // namespace

const OpRow& row_of(Op op) { return kRows[static_cast<std::size_t>(op)]; }

}  // namespace mirada::vm
