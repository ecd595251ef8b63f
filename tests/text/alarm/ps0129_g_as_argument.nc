O1 (PS0129: G90 behind G65)
G65 P2 A1. G90 (expect alarm PS0129 at G90)
M30
O2
M99
