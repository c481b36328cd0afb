#pragma once
#include "base/message.h"

namespace mirada::server::messages {

inline constexpr Message address_bad{
    "address_bad",
    "I can't listen on {address}. Give an address of this machine, such as 127.0.0.1 or 0.0.0.0.",
    "No puedo escuchar en {address}. Da una dirección de esta máquina, como 127.0.0.1 o 0.0.0.0."};
inline constexpr Message port_busy{
    "port_busy",
    "Port {port} is taken by another program. Stop that one, or choose another port with --port.",
    "El puerto {port} lo usa otro programa. Ciérralo o elige otro puerto con --port."};
inline constexpr Message port_forbidden{
    "port_forbidden", "I may not use port {port}. Choose one above 1023 with --port.",
    "No puedo usar el puerto {port}. Elige uno mayor que 1023 con --port."};
inline constexpr Message cannot_listen{"cannot_listen", "I can't listen on {address}, port {port}: {reason}.",
                                       "No puedo escuchar en {address}, puerto {port}: {reason}."};

inline constexpr Message robot_taken{
    "robot_taken", "Somebody else is driving now. You can watch, and you can always stop the robot.",
    "Ahora conduce otra persona. Puedes mirar, y siempre puedes parar el robot."};
inline constexpr Message not_driving{"not_driving", "Take the robot first: press the green flag.",
                                     "Primero toma el robot: pulsa la bandera verde."};
inline constexpr Message code_needed{"code_needed", "Type the join code of this robot to drive it.",
                                     "Escribe el código de este robot para conducirlo."};
inline constexpr Message code_wrong{"code_wrong", "That is not the code of this robot. Look at it again.",
                                    "Ese no es el código de este robot. Míralo otra vez."};
inline constexpr Message code_wait{"code_wait", "Too many tries. Wait a minute and type the code again.",
                                   "Demasiados intentos. Espera un minuto y escribe el código otra vez."};
inline constexpr Message teacher_code_needed{
    "teacher_code_needed",
    "Only a teacher can allow this. Type the teacher's code: it stands where Mirada was started.",
    "Solo un profesor puede permitirlo. Escribe el código del profesor: está donde se arrancó Mirada."};
inline constexpr Message owner_gone{"owner_gone", "The driver is gone, so the robot stopped.",
                                    "Quien conducía ya no está, así que el robot se ha parado."};
inline constexpr Message start_stopped{"start_stopped",
                                       "Somebody pressed Stop before the program had started.",
                                       "Alguien pulsó Parar antes de que empezara el programa."};
inline constexpr Message too_fast{"too_fast",
                                  "That was very fast: some of it was left out. Stop always works.",
                                  "Eso fue muy rápido: una parte no se ha hecho. Parar siempre funciona."};
inline constexpr Message robot_busy{
    "robot_busy", "The robot is still busy with what you asked before. Try again in a moment.",
    "El robot aún está con lo anterior. Prueba otra vez en un momento."};

inline constexpr Message message_broken{
    "message_broken", "This message is not one whole JSON object (it breaks at byte {byte}).",
    "Este mensaje no es un objeto JSON completo (se rompe en el byte {byte})."};
inline constexpr Message message_unknown{"message_unknown",
                                         "I don't know messages of type {value}. Known here: {known}.",
                                         "No conozco mensajes de tipo {value}. Aquí valen: {known}."};
inline constexpr Message message_too_large{"message_too_large", "This is too large: at most {limit_kib} KiB.",
                                           "Esto es demasiado grande: como mucho {limit_kib} KiB."};
inline constexpr Message version_unknown{"version_unknown",
                                         "This robot speaks version 1 of the protocol. Reload the page.",
                                         "Este robot habla la versión 1 del protocolo. Recarga la página."};

inline constexpr Message host_wrong{
    "host_wrong", "That is not the address of this robot. Open the address that the robot printed.",
    "Esa no es la dirección de este robot. Abre la dirección que mostró el robot."};
inline constexpr Message host_needed{"host_needed", "The request must have one Host line.",
                                     "La petición debe llevar una línea Host."};
inline constexpr Message origin_wrong{"origin_wrong", "Another page may not talk to this robot.",
                                      "Otra página no puede hablar con este robot."};
inline constexpr Message request_broken{"request_broken", "I can't read this request.",
                                        "No entiendo esta petición."};
inline constexpr Message request_chunked{"request_chunked", "Send the request with one Content-Length.",
                                         "Envía la petición con un solo Content-Length."};
inline constexpr Message header_too_large{"header_too_large", "The request's header is larger than 8 KiB.",
                                          "La cabecera de la petición ocupa más de 8 KiB."};
inline constexpr Message body_too_large{"body_too_large", "This is too large: at most {limit_kib} KiB.",
                                        "Esto es demasiado grande: como mucho {limit_kib} KiB."};
inline constexpr Message page_missing{"page_missing", "There is nothing at this address.",
                                      "No hay nada en esta dirección."};
inline constexpr Message method_wrong{"method_wrong", "This address can't be used that way.",
                                      "Esta dirección no se usa así."};
inline constexpr Message server_full{
    "server_full", "The robot has all the visitors it can take. Try again in a moment.",
    "El robot no puede atender a más visitas. Prueba otra vez en un momento."};
inline constexpr Message editor_missing{
    "editor_missing", "The editor is not built yet. Run scripts/run once, then reload this page.",
    "El editor aún no está construido. Ejecuta scripts/run una vez y recarga esta página."};
inline constexpr Message robot_works{"robot_works", "The robot itself is ready.", "El robot ya está listo."};
inline constexpr Message key_unknown{"key_unknown", "I do not know that key.", "No conozco esa tecla."};
inline constexpr Message client_needed{
    "client_needed", "{field} must be 8 to 64 letters, digits, dashes or underscores.",
    "{field} debe tener de 8 a 64 letras, cifras, guiones o guiones bajos."};
inline constexpr Message name_too_long{"name_too_long", "{field} must have 1 to {max} characters.",
                                       "{field} debe tener de 1 a {max} caracteres."};
inline constexpr Message text_too_long{"text_too_long", "{field} may have at most {max} bytes.",
                                       "{field} puede tener como mucho {max} bytes."};

}  // namespace mirada::server::messages
