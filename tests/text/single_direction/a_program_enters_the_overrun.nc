O1 (section 7.4: P2 is the second axis)
G10 L50
N5440 P2 R-1.
G11
G60 X5. Y5. (expect moves: rapid X5 Y6; rapid X5 Y5)
M30
(finally assumed: none)
