#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message hold_middle{"hold_middle", "Hold the board in the middle of the picture.",
                                     "Pon el tablero en el centro de la imagen."};
inline constexpr Message hold_top_left{"hold_top_left", "Now into the upper left corner.",
                                       "Ahora en la esquina de arriba a la izquierda."};
inline constexpr Message hold_top_right{"hold_top_right", "Now into the upper right corner.",
                                        "Ahora en la esquina de arriba a la derecha."};
inline constexpr Message hold_bottom_left{"hold_bottom_left", "Now into the lower left corner.",
                                          "Ahora en la esquina de abajo a la izquierda."};
inline constexpr Message hold_bottom_right{"hold_bottom_right", "Now into the lower right corner.",
                                           "Ahora en la esquina de abajo a la derecha."};
inline constexpr Message hold_top_near{"hold_top_near", "Tilt it: its upper edge towards the camera.",
                                       "Inclínalo: el borde de arriba hacia la cámara."};
inline constexpr Message hold_bottom_near{"hold_bottom_near", "Tilt it: its lower edge towards the camera.",
                                          "Inclínalo: el borde de abajo hacia la cámara."};
inline constexpr Message hold_left_near{"hold_left_near",
                                        "Turn it: the picture's left side of it towards the camera.",
                                        "Gíralo: el lado izquierdo de la imagen hacia la cámara."};
inline constexpr Message hold_right_near{"hold_right_near",
                                         "Turn it: the picture's right side of it towards the camera.",
                                         "Gíralo: el lado derecho de la imagen hacia la cámara."};
inline constexpr Message hold_near{"hold_near", "Bring it near, so that it nearly fills the picture.",
                                   "Acércalo hasta que casi llene la imagen."};
inline constexpr Message hold_left_edge{"hold_left_edge", "To the left edge, tilted.",
                                        "Al borde izquierdo, inclinado."};
inline constexpr Message hold_right_edge{"hold_right_edge", "To the right edge, tilted.",
                                         "Al borde derecho, inclinado."};
inline constexpr Message hold_top_edge{"hold_top_edge", "Up to the upper edge, tilted.",
                                       "Arriba, junto al borde, inclinado."};
inline constexpr Message hold_bottom_edge{"hold_bottom_edge", "Down to the lower edge, tilted.",
                                          "Abajo, junto al borde, inclinado."};
inline constexpr Message hold_elsewhere{"hold_elsewhere",
                                        "Show it where it has not been yet, and tilt it another way.",
                                        "Enséñalo donde aún no ha estado, y con otra inclinación."};

inline constexpr Message guide_taken{"guide_taken", "Got it!", "¡Ya la tengo!"};
inline constexpr Message guide_moving{"guide_moving", "I see it. Hold it still for a moment.",
                                      "Lo veo. No lo muevas un momento."};
inline constexpr Message guide_known{"guide_known", "I have a picture like this. Move it or tilt it.",
                                     "Ya tengo una así. Muévelo o inclínalo."};
inline constexpr Message guide_unclear{"guide_unclear", "I can't make out how it is held. Show it flatter.",
                                       "No distingo cómo está. Enséñalo más de frente."};
inline constexpr Message guide_full{"guide_full", "That is as many as I need.", "Ya no necesito más."};
inline constexpr Message guide_working{"guide_working", "Working it out…", "Estoy calculando…"};

inline constexpr Message guide_good{"guide_good",
                                    "Your camera sees {hfov} degrees from side to side and {vfov} from top "
                                    "to bottom. The board's corners lie "
                                    "within {rms} pixels of where they should ({max} are allowed).",
                                    "Tu cámara abarca {hfov} grados de lado a lado y {vfov} de arriba abajo. "
                                    "Las esquinas del tablero están a "
                                    "{rms} píxeles de donde deben (caben {max})."};
inline constexpr Message guide_poor{"guide_poor", "I would not trust this yet. Go on with more pictures:",
                                    "Aún no me fiaría. Sigue con más imágenes:"};
inline constexpr Message guide_saved{
    "guide_saved", "Saved in {file}. The robot uses it from now on, and after a restart.",
    "Guardado en {file}. El robot ya lo usa, y también después de reiniciarse."};
inline constexpr Message guide_kept_old{"guide_kept_old", "The one before is kept as {file}.",
                                        "El anterior queda como {file}."};
inline constexpr Message guide_few{"guide_few", "{value} pictures are too few; {min} are needed.",
                                   "{value} imágenes son pocas; hacen falta {min}."};
inline constexpr Message guide_not_now{"guide_not_now", "There is nothing to do that with just now.",
                                       "Ahora no hay con qué hacer eso."};
inline constexpr Message guide_no_camera{"guide_no_camera", "This robot has no camera.",
                                         "Este robot no tiene cámara."};
inline constexpr Message guide_size_changed{
    "guide_size_changed", "The pictures changed from {wanted} to {value}, so I start again.",
    "Las imágenes pasaron de {wanted} a {value}, así que empiezo otra vez."};

}  // namespace mirada::messages
