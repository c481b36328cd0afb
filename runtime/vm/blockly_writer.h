#pragma once
#include <cstddef>
#include <string>

#include "vm/ast.h"
#include "vm/catalog.h"

namespace mirada::vm {

/// A longer list of a Scratch file is empty in the editor: each item is a block there.
constexpr std::size_t kMostKeptItems = 500;

/// A read Scratch project as a program of the editor's (docs/program-format.md), as JSON text. All sprites'
/// scripts stand on one canvas, side by side; a sprite's own variables are called "Sprite: name", and so are
/// its my-blocks where two sprites have the same. Blocks that the catalog does not have keep their Scratch
/// form, which the editor shows as placeholders. The program must not be nested deeper than limits::kNesting.
std::string write_blockly(const Program& program, const BlockCatalog& catalog, const std::string& name);

}  // namespace mirada::vm
