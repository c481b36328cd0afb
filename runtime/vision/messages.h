#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message face_cascade_missing{
    "face_cascade_missing",
    "I can't find faces: the file {file} is missing. Install Debian's package opencv-data.",
    "No puedo buscar caras: falta el archivo {file}. Instala el paquete opencv-data de Debian."};
inline constexpr Message face_cascade_broken{
    "face_cascade_broken",
    "I can't find faces: {file} is no face cascade. Install Debian's package opencv-data again.",
    "No puedo buscar caras: {file} no es una cascada de caras. Vuelve a instalar el paquete opencv-data de "
    "Debian."};

}  // namespace mirada::messages
