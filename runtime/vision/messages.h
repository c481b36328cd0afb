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
inline constexpr Message face_identity_plain{
    "face_identity_plain",
    "I tell faces apart in the plain way (local patterns), because the networks for it are not here. Start "
    "me with scripts/run while there is internet, and they are fetched.",
    "Distingo las caras de la manera sencilla (patrones locales), porque las redes para ello no están aquí. "
    "Arráncame con scripts/run cuando haya internet y se descargarán."};
inline constexpr Message face_book_broken{
    "face_book_broken", "The learnt faces in {file} can't be read. Mend the file or delete it.",
    "No se pueden leer las caras aprendidas de {file}. Arregla el archivo o bórralo."};
inline constexpr Message face_book_left{
    "face_book_left", "Until then I know nobody, and whom I learn now I forget when I am switched off.",
    "Hasta entonces no conozco a nadie, y a quien aprenda ahora lo olvido al apagarme."};
inline constexpr Message face_book_full{"face_book_full",
                                        "I can't learn more than {max} people. Forget somebody first.",
                                        "No puedo aprender más de {max} personas. Olvida antes a alguien."};
inline constexpr Message face_unknown_name{"face_unknown_name", "I know nobody called {name}.",
                                           "No conozco a nadie que se llame {name}."};
inline constexpr Message face_name_taken{"face_name_taken", "I already know somebody called {name}.",
                                         "Ya conozco a alguien que se llama {name}."};
inline constexpr Message face_name_bad{"face_name_bad", "A name needs 1 to {max} characters.",
                                       "Un nombre necesita de 1 a {max} caracteres."};
inline constexpr Message lesson_show_face{"lesson_show_face", "Show me your face.", "Enséñame tu cara."};
inline constexpr Message lesson_closer{"lesson_closer", "Come a little closer.", "Acércate un poco."};
inline constexpr Message lesson_one_only{"lesson_one_only", "Only one person in the picture, please.",
                                         "Solo una persona en la imagen, por favor."};
inline constexpr Message lesson_look_here{"lesson_look_here", "Look at me.", "Mírame."};
inline constexpr Message lesson_move{"lesson_move", "Good! Move your head a little.",
                                     "¡Bien! Mueve un poco la cabeza."};

}  // namespace mirada::messages
