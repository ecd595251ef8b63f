O1 (VAR-6: Z-#18 with 20.)
#18=20.
G90 G00 Z-#18 (expect moves: rapid Z-20)
M30
