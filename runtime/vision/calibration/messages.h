#pragma once
#include "base/message.h"

namespace mirada::messages {

inline constexpr Message board_grid{
    "board_grid", "{value} is no board: two whole numbers from {min} to {max} with an x between, like 9x6.",
    "{value} no es un tablero: dos números enteros de {min} a {max} con una x en medio, como 9x6."};
inline constexpr Message board_length{
    "board_length", "{value} mm can't be right: measure it with a ruler ({min} to {max} mm).",
    "{value} mm no puede ser: mídelo con una regla (de {min} a {max} mm)."};
inline constexpr Message board_dictionary{"board_dictionary",
                                          "I don't know the marks {value}. Choose 4x4, 5x5, 6x6 or 36h11.",
                                          "No conozco las marcas {value}. Elige 4x4, 5x5, 6x6 o 36h11."};
inline constexpr Message board_too_many_marks{
    "board_too_many_marks", "This board would bear {marks} marks; the dictionary has {max}.",
    "Ese tablero llevaría {marks} marcas; el diccionario tiene {max}."};

inline constexpr Message picture_unreadable{
    "picture_unreadable", "This is no picture that I can read. Take it again as JPEG or PNG.",
    "No es una imagen que pueda leer. Hazla otra vez en JPEG o PNG."};
inline constexpr Message picture_too_small{
    "picture_too_small",
    "{width}x{height} pixels are too few; {min} each way are needed. Take a larger picture.",
    "{width}x{height} píxeles son pocos; hacen falta {min} a cada lado. Haz una foto más grande."};
inline constexpr Message picture_too_large{
    "picture_too_large", "{width}x{height} pixels are too many; {max} each way are enough.",
    "{width}x{height} píxeles son demasiados; bastan {max} a cada lado."};
inline constexpr Message picture_black{"picture_black",
                                       "The picture is black. Take the lens cap off or switch a light on.",
                                       "La imagen está negra. Quita la tapa o enciende una luz."};
inline constexpr Message picture_white{
    "picture_white", "The picture is white: too much light. Turn the camera from the lamp.",
    "La imagen está blanca: hay demasiada luz. Aparta la cámara de la lámpara."};
inline constexpr Message picture_flat{"picture_flat",
                                      "There is nothing to see in this picture: it is all grey.",
                                      "En esta imagen no se ve nada: es toda gris."};
inline constexpr Message picture_other_size{
    "picture_other_size",
    "This picture is {value}, most are {wanted}. Take them all with one camera setting.",
    "Esta imagen es de {value} y la mayoría de {wanted}. Hazlas todas con el mismo ajuste de la cámara."};

inline constexpr Message board_not_seen{
    "board_not_seen", "I see no board with {wanted} inner corners. Show all of it, flat, in even light.",
    "No veo un tablero de {wanted} esquinas interiores. Enséñalo entero, plano y con luz pareja."};
inline constexpr Message board_cut_off{"board_cut_off",
                                       "The board is cut off by the picture's edge: I see {seen} of {wanted} "
                                       "inner corners. Move it in or farther away.",
                                       "El borde de la imagen corta el tablero: veo {seen} de {wanted} "
                                       "esquinas interiores. Mételo entero o aléjalo."};
inline constexpr Message board_other_size{
    "board_other_size",
    "I count {seen} inner corners, not {wanted}. Is it another board, or is a part of it covered?",
    "Cuento {seen} esquinas interiores, no {wanted}. ¿Es otro tablero, o está tapado en parte?"};
inline constexpr Message board_larger{
    "board_larger",
    "The board goes on beyond {wanted} inner corners. Count its corners again (not its squares).",
    "El tablero sigue más allá de {wanted} esquinas interiores. Cuenta otra vez sus esquinas (no sus "
    "casillas)."};
inline constexpr Message board_blurred{
    "board_blurred",
    "Blurred: an edge is {value} pixels wide, {max} are allowed. Hold still, focus, or get more light.",
    "Borrosa: un borde ocupa {value} píxeles y caben {max}. No la muevas, enfoca o pon más luz."};
inline constexpr Message board_from_screen{
    "board_from_screen",
    "The dark squares are striped ({value} %, {max} are allowed), as on a screen. Print the board on paper.",
    "Las casillas oscuras tienen rayas ({value} %, caben {max}), como en una pantalla. Imprime el tablero."};
inline constexpr Message charuco_few_marks{
    "charuco_few_marks",
    "I see {seen} of the board's marks; {min} are needed. Bring it nearer, in even light.",
    "Veo {seen} marcas del tablero; hacen falta {min}. Acércalo, con luz pareja."};
inline constexpr Message charuco_other_board{
    "charuco_other_board",
    "The marks do not stand as on a board of {wanted} squares. Count the squares and check the dictionary.",
    "Las marcas no están como en un tablero de {wanted} casillas. Cuenta las casillas y mira el "
    "diccionario."};
inline constexpr Message charuco_too_little{
    "charuco_too_little", "Only {seen} corners of the board are seen; {min} are needed. Show more of it.",
    "Solo se ven {seen} esquinas del tablero; hacen falta {min}. Enseña más."};

inline constexpr Message view_repeated{
    "view_repeated", "The board is where it was in {other}. Move or tilt it between pictures.",
    "El tablero está donde estaba en {other}. Muévelo o inclínalo entre foto y foto."};
inline constexpr Message view_does_not_fit{
    "view_does_not_fit",
    "The corners miss a flat board by {value} pixels ({max} are allowed). Was it bent, or moving?",
    "Las esquinas se apartan {value} píxeles de un tablero plano (caben {max}). ¿Estaba doblado o "
    "moviéndose?"};

inline constexpr Message set_too_few{"set_too_few",
                                     "{value} usable pictures are too few; {min} are needed, 12 are good.",
                                     "{value} imágenes útiles son pocas; hacen falta {min}, y 12 van bien."};
inline constexpr Message set_not_tilted{"set_not_tilted",
                                        "The board is held almost the same way in all pictures ({value} "
                                        "degrees apart; {min} are needed). Tilt it.",
                                        "El tablero está casi igual en todas las imágenes ({value} grados de "
                                        "diferencia; hacen falta {min}). Inclínalo."};
inline constexpr Message set_covers_little{
    "set_covers_little",
    "The board has been shown in {value} % of the picture; {min} % are needed. Missing most: {where}.",
    "El tablero se ha enseñado en el {value} % de la imagen; hace falta el {min} %. Falta sobre todo: "
    "{where}."};
inline constexpr Message set_rms_high{
    "set_rms_high",
    "The corners miss by {value} pixels on average ({max} are allowed). Is the board flat and the focus "
    "fixed?",
    "Las esquinas fallan {value} píxeles de media (caben {max}). ¿Está plano el tablero y fijo el enfoque?"};
inline constexpr Message set_focal_unsure{"set_focal_unsure",
                                          "The focal length is only known to {value} % ({max} are allowed). "
                                          "Add pictures with the board tilted more.",
                                          "La distancia focal solo se conoce al {value} % (cabe el {max}). "
                                          "Añade fotos con el tablero más inclinado."};
inline constexpr Message set_not_solved{
    "set_not_solved", "No lens fits these pictures. Were they all taken with one camera, without zoom?",
    "Ninguna lente encaja con estas imágenes. ¿Se hicieron todas con una cámara y sin zoom?"};
inline constexpr Message set_pixels_not_square{"set_pixels_not_square",
                                               "The pixels would not be square (fx : fy is {value}; {min} to "
                                               "{max} is allowed). Are the pictures stretched?",
                                               "Los píxeles no serían cuadrados (fx : fy es {value}; vale de "
                                               "{min} a {max}). ¿Están estiradas las imágenes?"};
inline constexpr Message set_centre_far{"set_centre_far",
                                        "The lens's centre would be {value} % of the picture off its middle "
                                        "({max} are allowed). Are the pictures cut?",
                                        "El centro de la lente estaría a un {value} % del medio de la imagen "
                                        "(cabe el {max}). ¿Están recortadas?"};
inline constexpr Message set_lens_folds{
    "set_lens_folds", "The lens model folds over at the picture's edge. Show the board near the edges too.",
    "El modelo de lente se pliega en el borde de la imagen. Enseña el tablero también junto a los bordes."};

inline constexpr Message set_board_stretched{
    "set_board_stretched",
    "The squares are {value} % wider than high ({max} % is allowed): was the board on a screen, or printed "
    "stretched? Measure both sides of a square.",
    "Las casillas son un {value} % más anchas que altas (cabe el {max} %): ¿estaba en una pantalla, o se "
    "imprimió estirado? Mide los dos lados de una casilla."};
inline constexpr Message set_board_bent{"set_board_bent",
                                        "The board is bent by about {value} mm. Glue it to something flat.",
                                        "El tablero está doblado unos {value} mm. Pégalo a algo plano."};

inline constexpr Message view_unlike_datasheet{
    "view_unlike_datasheet", "This camera sees {value} degrees across, but a {camera} sees {wanted}.",
    "Esta cámara abarca {value} grados, pero una {camera} abarca {wanted}."};
inline constexpr Message view_fits_other{"view_fits_other", "That is a {camera}'s view: is it that camera?",
                                         "Es lo que abarca una {camera}: ¿es esa cámara?"};
inline constexpr Message view_fits_none{
    "view_fits_none", "Check the square count, the pictures' size and the lens.",
    "Revisa el número de casillas, el tamaño de las imágenes y la lente."};
inline constexpr Message view_shape_unknown{
    "view_shape_unknown", "A {camera} has no {value} mode that I know, so its view was not checked.",
    "No conozco un modo de {value} en una {camera}, así que no he comprobado lo que abarca."};

inline constexpr Message zone_top{"zone_top", "top", "arriba"};
inline constexpr Message zone_bottom{"zone_bottom", "bottom", "abajo"};
inline constexpr Message zone_left{"zone_left", "left", "izquierda"};
inline constexpr Message zone_right{"zone_right", "right", "derecha"};
inline constexpr Message zone_middle{"zone_middle", "middle", "centro"};

}  // namespace mirada::messages
