(run with: --machine lathe3c --set #2901=3 --set #2301=9)
O1 (turning, polar interpolation: G40 in a block that moves Z alone leaves the offset to a move that does not come)
G98 G00 X80. Z5. C0 T0101
G12.1
G42 G01 X40. F200.
C10. (expect moves: line X50.1597 C23.4986)
G40 Z8. (expect moves: line X50.1597 Z8 C23.4986)
G13.1
G01 X60. (expect moves: line X60 Z8 C23.4986)
M30
