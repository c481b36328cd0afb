// From bytes to one of the two readers.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include <zip.h>

#include "base/messages.h"
#include "vm/json_tree.h"
#include "vm/messages.h"
#include "vm/reader.h"

namespace mirada::vm {
namespace {

constexpr std::size_t kMaxProject = 16u << 20;  // of project.json, unpacked
constexpr std::size_t kMaxArchive = 64u << 20;

ReadProgram broken(const Message& why, MessageArgs args = {}) {
  ReadProgram out;
  out.faults.push_back(make_fault("", why, std::move(args)));
  return out;
}

ReadProgram too_large() {
  return broken(messages::archive_too_large, {{"limit_mib", std::to_string(kMaxProject >> 20)}});
}

ReadProgram program_too_large(std::size_t bytes) {
  return broken(messages::program_too_large,
                {{"bytes", std::to_string(bytes)}, {"limit", std::to_string(limits::kProgramBytes)}});
}

/// How many folders project.json lies in by this name, "." being no folder; none when the name says something
/// else or tries to lead elsewhere.
std::optional<std::size_t> folders_above_project(std::string_view name) {
  if (name.find('\\') != std::string_view::npos) return std::nullopt;
  std::size_t folders = 0;
  for (std::size_t slash = name.find('/'); slash != std::string_view::npos; slash = name.find('/')) {
    const std::string_view folder = name.substr(0, slash);
    name.remove_prefix(slash + 1);
    if (folder == ".") continue;
    if (folder.empty() || folder[0] == '.') return std::nullopt;
    ++folders;
  }
  return name == "project.json" ? std::optional(folders) : std::nullopt;
}

/// project.json, at the top or (as Scratch allows) in a folder; nothing else is looked at.
zip_int64_t find_project(zip_t* archive) {
  zip_int64_t in_folder = -1;
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive, static_cast<zip_uint64_t>(i), 0);
    const std::optional<std::size_t> folders = folders_above_project(name ? name : "");
    if (folders == 0U) return i;
    if (folders == 1U && in_folder < 0) in_folder = i;
  }
  return in_folder;
}

ReadProgram old_scratch(const char* version) { return broken(messages::old_scratch, {{"version", version}}); }

/// What a text that is no JSON was meant to be.
bool looks_like_project(std::string_view text) {
  const std::size_t targets = text.find("\"targets\"");
  const std::size_t blockly = std::min(text.find("\"workspace\""), text.find("\"languageVersion\""));
  return targets != std::string_view::npos && targets < blockly;
}

ReadProgram broken_json(const JsonTree::Broken& where, bool project) {
  const std::string byte = where.number_too_large ? "-" : std::to_string(where.byte);
  if (project) return broken(messages::project_broken, {{"byte", byte}});
  if (where.number_too_large) return broken(mirada::messages::json_number_too_large);
  return broken(mirada::messages::json_broken, {{"byte", byte}});
}

/// Told apart by the outermost fields: Scratch 3 has targets there, Scratch 2 the stage itself.
ReadProgram read_json(std::string_view text, bool from_archive) {
  const JsonTree tree = JsonTree::parse(text);
  if (tree.broken()) return broken_json(*tree.broken(), from_archive || looks_like_project(text));
  const JsonValue root = tree.root();
  const bool ours = !from_archive && root.find("workspace");
  if (!ours && !root.find("targets") && root.find("objName")) return old_scratch("2");
  if (from_archive || (!ours && root.find("targets"))) return read_scratch_project(root);
  if (text.size() > limits::kProgramBytes) return program_too_large(text.size());
  return read_blockly(root);
}

/// Only project.json is unpacked, from memory to memory and never more than the limit: no path and no bomb
/// matters.
ReadProgram read_archive(std::string_view bytes) {
  if (bytes.size() > kMaxArchive) return too_large();
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* opened = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr;
  zip_error_fini(&error);
  if (!opened) {
    if (source) zip_source_free(source);
    return broken(messages::archive_broken);
  }
  const std::unique_ptr<zip_t, void (*)(zip_t*)> archive(opened, [](zip_t* z) { zip_discard(z); });
  const zip_int64_t index = find_project(archive.get());
  if (index < 0) {
    const bool sprite = zip_name_locate(archive.get(), "sprite.json", 0) >= 0;
    return broken(sprite ? messages::only_a_sprite : messages::archive_without_project);
  }
  zip_file_t* entry = zip_fopen_index(archive.get(), static_cast<zip_uint64_t>(index), 0);
  if (!entry) return broken(messages::archive_broken);
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(entry, zip_fclose);
  std::string text;
  std::array<char, 65536> chunk{};
  for (;;) {
    const zip_int64_t got = zip_fread(file.get(), chunk.data(), chunk.size());
    if (got < 0) return broken(messages::archive_broken);
    if (got == 0) break;
    text.append(chunk.data(), static_cast<std::size_t>(got));
    if (text.size() > kMaxProject) return too_large();
  }
  return read_json(text, true);
}

}  // namespace

ReadProgram read_program(std::string_view bytes) {
  if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06")) return read_archive(bytes);
  if (bytes.starts_with("ScratchV0")) return old_scratch("1");
  if (bytes.size() <= kMaxProject) return read_json(bytes, false);
  return looks_like_project(bytes) ? too_large() : program_too_large(bytes.size());
}

}  // namespace mirada::vm
