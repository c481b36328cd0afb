#include "rig/shipped_packs.h"

#include "base/files.h"
#include "rig/station_factory.h"

namespace mirada::rig {

packs::PackSet shipped_packs(const std::shared_ptr<const blocks::Link>& link) {
  return packs::load_packs(data_folder("blocks"), blocks::native_blocks(link));
}

std::shared_ptr<const packs::PackSet> load_shipped_packs() {
  return std::make_shared<const packs::PackSet>(shipped_packs(std::make_shared<const blocks::Link>()));
}

}  // namespace mirada::rig
