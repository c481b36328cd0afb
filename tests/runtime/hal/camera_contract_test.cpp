#include "camera_contract_cases.h"

namespace mirada::hal {

CameraUnderTest make_replay();
CameraUnderTest make_grabber();

INSTANTIATE_TEST_SUITE_P(Real, CameraContract,
                         testing::Values(CameraMaker{"replay", make_replay},
                                         CameraMaker{"grabber", make_grabber}),
                         [](const auto& maker) { return maker.param.name; });

}  // namespace mirada::hal
