#pragma once
#include <cstdint>
#include <string>

#include "vm/catalog.h"

namespace mirada::vm::reference {

/// Grows a program out of the bytes, runs it on the machine and in the reference evaluator, and says where
/// they differ; empty when they agree, or when the program does too much to be compared.
std::string difference(const std::uint8_t* data, std::size_t size, const BlockCatalog& catalog);

}  // namespace mirada::vm::reference
