O1 (CYC-13: X5. is not allowed there)
G90 G00 Z10.
M29 S500
X5.
G84 X0 Y0 Z-10. R2. F500
M30
(finally alarm PS0204)
