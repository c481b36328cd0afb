#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message mount_no_pose{
    "mount_no_pose", "What I see fits no flat thing before this camera. Is it the right robot file?",
    "Lo que veo no encaja con nada plano ante esta cámara. ¿Es el archivo de robot correcto?"};
inline constexpr Message mount_lines_unsettled{
    "mount_lines_unsettled",
    "These lines do not settle height and tilt. Give two or more at different distances.",
    "Esas líneas no fijan la altura y la inclinación. Da dos o más a distintas distancias."};
inline constexpr Message mount_not_on_floor{"mount_not_on_floor",
                                            "The camera would look {value} degrees down ({min} to {max} is "
                                            "possible). Lay the board or tag on the floor.",
                                            "La cámara miraría {value} grados hacia abajo (vale de {min} a "
                                            "{max}). Pon el tablero o la marca en el suelo."};
inline constexpr Message mount_rolled{
    "mount_rolled",
    "The camera would hang {value} degrees to a side ({max} are allowed). Is the board flat on the floor?",
    "La cámara estaría {value} grados de lado (caben {max}). ¿Está el tablero plano en el suelo?"};
inline constexpr Message mount_height_range{
    "mount_height_range",
    "The lens would be {value} cm high ({min} to {max} is possible). Check the sizes given.",
    "La lente estaría a {value} cm de altura (vale de {min} a {max}). Revisa las medidas dadas."};
inline constexpr Message mount_unsure{
    "mount_unsure",
    "Too unsure: tilt +- {tilt} degrees ({max_tilt} allowed), height +- {height} mm ({max_height} allowed). "
    "Bring the board nearer.",
    "Demasiado inseguro: inclinación +- {tilt} grados (cabe {max_tilt}), altura +- {height} mm (cabe "
    "{max_height}). Acerca el tablero."};
inline constexpr Message mount_height_differs{
    "mount_height_differs",
    "I measure the lens {value} cm high; the robot's file says {told}. Check the square or tag size with a "
    "ruler; if it is right, correct the file first.",
    "Mido la lente a {value} cm de altura; el archivo dice {told}. Revisa con una regla la casilla o la "
    "marca; "
    "si está bien, corrige antes el archivo."};
inline constexpr Message mount_tilt_differs{
    "mount_tilt_differs",
    "I measure {value} degrees of tilt; the robot's file says {told}. Where did the neck point? If it is "
    "right, "
    "correct the file first.",
    "Mido {value} grados de inclinación; el archivo dice {told}. ¿Adónde apuntaba el cuello? Si está bien, "
    "corrige antes el archivo."};
inline constexpr Message mount_cannot_tell{
    "mount_cannot_tell", "I can't check the camera from here: put the board or tag nearer to the robot.",
    "Desde aquí no puedo comprobar la cámara: pon el tablero o la marca más cerca del robot."};
inline constexpr Message mount_knocked_tilt{
    "mount_knocked_tilt",
    "The camera has been knocked: it looks {value} degrees down, not {told}. Put it back or measure it "
    "again.",
    "La cámara se ha movido: mira {value} grados hacia abajo, no {told}. Colócala o mídela otra vez."};
inline constexpr Message mount_knocked_roll{
    "mount_knocked_roll",
    "The camera has been knocked: it hangs {value} degrees to a side, not {told}. Put it back or measure it "
    "again.",
    "La cámara se ha movido: está {value} grados de lado, no {told}. Colócala o mídela otra vez."};
inline constexpr Message mount_knocked_height{
    "mount_knocked_height",
    "The camera has been moved: it is {value} cm high, not {told}. Put it back or measure it again.",
    "La cámara se ha movido: está a {value} cm de altura, no {told}. Colócala o mídela otra vez."};

}  // namespace mirada::messages
