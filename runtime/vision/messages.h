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
inline constexpr Message face_net_missing{"face_net_missing", "I can't find the face model {file}.",
                                          "No encuentro el modelo de caras {file}."};
inline constexpr Message face_net_broken{
    "face_net_broken",
    "{file} is no face model that I can use. I need an ONNX file in the shape of UltraFace, 320 x 240 or "
    "640 x 480.",
    "{file} no es un modelo de caras que pueda usar. Necesito un archivo ONNX con la forma de UltraFace, de "
    "320 x 240 o 640 x 480."};
inline constexpr Message face_net_not_fetched{
    "face_net_not_fetched",
    "I look for faces in the plain way (Haar), because the better face model is not here. Start me with "
    "scripts/run while there is internet, and it is fetched.",
    "Busco caras de la manera sencilla (Haar), porque el modelo mejor no está aquí. Arráncame con "
    "scripts/run "
    "cuando haya internet y se descargará."};

}  // namespace mirada::messages
