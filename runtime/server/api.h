#pragma once
#include <string>
#include <vector>

#include "base/message.h"
#include "packs/packs.h"
#include "server/examples.h"
#include "session/station.h"

namespace mirada::server {

// The bodies of GET /api/*. The first and the third never change while the server runs.
std::string packs_json(const packs::PackSet& packs);
std::string setup_page_json(const session::Station& station, Lang lang);
std::string examples_json(const std::vector<Example>& examples);

/// POST /api/check: reads, validates and compiles; takes as long as that. Any thread.
std::string check_program(const std::string& program_json, const packs::PackSet& packs);

/// POST /api/scratch: a Scratch file as a program for the editor, and what was left out; program null when it
/// is refused. Any thread.
std::string open_scratch(const std::string& bytes, const packs::PackSet& packs);

/// A small page in both languages, for people who open an address without an editor behind it.
std::string plain_page(const Message& what, const MessageArgs& args = {}, const Message* also = nullptr);

}  // namespace mirada::server
