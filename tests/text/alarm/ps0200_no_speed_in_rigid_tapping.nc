O1 (PS0200: M29 without S)
M29
G84 X0 Y0 Z-10. R-2. F500
M30
(finally alarm PS0200)
