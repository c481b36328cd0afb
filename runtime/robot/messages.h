#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message no_robot{"no_robot", "There is no robot here to do this.",
                                  "Aquí no hay ningún robot que pueda hacer esto."};
inline constexpr Message no_drive{"no_drive", "This robot has no wheels, so it can't drive.",
                                  "Este robot no tiene ruedas, así que no puede moverse."};
inline constexpr Message no_neck{"no_neck", "This robot's camera can't turn.",
                                 "La cámara de este robot no puede girar."};
inline constexpr Message no_tilt{"no_tilt", "This robot's camera can't look up or down.",
                                 "La cámara de este robot no puede mirar arriba ni abajo."};
inline constexpr Message not_running{"not_running", "Press the green flag first: then I can move.",
                                     "Pulsa primero la bandera verde: entonces podré moverme."};
inline constexpr Message number_not_finite{"number_not_finite", "I need a real number here, not {value}.",
                                           "Aquí necesito un número de verdad, no {value}."};
inline constexpr Message beyond_limit{"beyond_limit", "I can't do {value} {unit}. Use {min} to {max}.",
                                      "No puedo con {value} {unit}. Usa de {min} a {max}."};
inline constexpr Message pan_clamped{
    "pan_clamped", "I can't look that far to the side: I look to {limit}° instead of {value}°.",
    "No puedo mirar tan a un lado: miro a {limit}° en vez de a {value}°."};
inline constexpr Message tilt_clamped{
    "tilt_clamped", "I can't look that far up or down: I look to {limit}° instead of {value}°.",
    "No puedo mirar tan arriba o abajo: miro a {limit}° en vez de a {value}°."};
inline constexpr Message not_getting_there{"not_getting_there",
                                           "I am not getting there. Is something in my way?",
                                           "No consigo llegar. ¿Hay algo en mi camino?"};
inline constexpr Message no_gap_there{"no_gap_there",
                                      "I know no gap there that I fit through. Look around first.",
                                      "Ahí no conozco ningún hueco por el que quepa. Mira antes alrededor."};
inline constexpr Message faces_unavailable{"faces_unavailable", "I can't look for faces here: {reason}",
                                           "Aquí no puedo buscar caras: {reason}"};

inline constexpr Message faces_not_allowed{
    "faces_not_allowed",
    "Learning and recognising faces is off here. A teacher can allow it, under Names… above the picture.",
    "Aprender y reconocer caras está apagado aquí. Un profesor puede permitirlo, en Nombres… encima de la "
    "imagen."};
inline constexpr Message face_not_learnt{
    "face_not_learnt",
    "I could not see the face well enough to learn it as {name}. Come near and look at me.",
    "No pude ver la cara lo bastante bien para aprenderla como {name}. Acércate y mírame."};

inline constexpr Message place_lost{"place_lost",
                                    "I don't know where I am. Let me see a tag of the map first.",
                                    "No sé dónde estoy. Déjame ver antes una etiqueta del mapa."};

}  // namespace mirada::messages
