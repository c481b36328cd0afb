#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message faces_are_on{"faces_are_on", "Learning and recognising faces is allowed.",
                                      "Se permite aprender y reconocer caras."};
inline constexpr Message faces_are_off{"faces_are_off", "Learning and recognising faces is off.",
                                       "Aprender y reconocer caras está apagado."};
inline constexpr Message faces_person{"faces_person", "{name}: {looks} looks", "{name}: {looks} miradas"};
inline constexpr Message faces_none_in_picture{"faces_none_in_picture",
                                               "I see no face in {file} that I could learn.",
                                               "No veo en {file} ninguna cara que pueda aprender."};

}  // namespace mirada::messages
