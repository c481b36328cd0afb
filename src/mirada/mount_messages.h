#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message mount_says_nothing{
    "mount_says_nothing", "Say what lies on the floor: --board with --square-mm, --tag-mm, or two --line.",
    "Di qué hay en el suelo: --board con --square-mm, --tag-mm, o dos --line."};
inline constexpr Message mount_says_twice{"mount_says_twice", "Choose one of --board, --tag-mm and --line.",
                                          "Elige uno de --board, --tag-mm y --line."};
inline constexpr Message mount_tag_size{
    "mount_tag_size", "{value} mm can't be right: measure the tag's black square (5 to 1000 mm).",
    "{value} mm no puede ser: mide el cuadrado negro de la marca (5 a 1000 mm)."};
inline constexpr Message mount_no_tag{"mount_no_tag",
                                      "I see no AprilTag 36h11 {which}here. Lay it flat, in even light.",
                                      "No veo aquí una AprilTag 36h11 {which}. Ponla plana, con luz pareja."};
inline constexpr Message mount_many_tags{"mount_many_tags",
                                         "I see the tags {seen}. Say which one with --tag-id.",
                                         "Veo las marcas {seen}. Di cuál con --tag-id."};
inline constexpr Message mount_line_text{
    "mount_line_text", "{value} is no line: u1,v1,u2,v2=x1,y1,x2,y2 (pixels, then metres before the robot).",
    "{value} no es una línea: u1,v1,u2,v2=x1,y1,x2,y2 (píxeles y luego metros ante el robot)."};
inline constexpr Message mount_picture_shape{
    "mount_picture_shape",
    "The picture is {value}; this robot's camera takes {wanted}. Use its own pictures.",
    "La imagen es de {value}; la cámara de este robot hace {wanted}. Usa imágenes suyas."};
inline constexpr Message mount_result{"mount_result",
                                      "lens {height} cm high (+- {sigma_height} mm), {tilt} degrees down (+- "
                                      "{sigma_tilt}), {roll} degrees of roll; rms "
                                      "{rms} px",
                                      "lente a {height} cm de altura (+- {sigma_height} mm), {tilt} grados "
                                      "hacia abajo (+- {sigma_tilt}), {roll} grados "
                                      "de lado; rms {rms} px"};
inline constexpr Message mount_as_told{"mount_as_told", "That is what the robot's file says.",
                                       "Es lo que dice el archivo del robot."};
inline constexpr Message mount_kept{"mount_kept", "Written to {file}.", "Escrito en {file}."};
inline constexpr Message mount_not_kept{"mount_not_kept",
                                        "For the robot's file:", "Para el archivo del robot:"};

}  // namespace mirada::messages
