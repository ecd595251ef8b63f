O1 (CYC-13: M29 without S)
G90 G00 Z10.
M29
G84 X0 Y0 Z-10. R2. F500
M30
(finally alarm PS0200)
