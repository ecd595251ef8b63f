O1 (section 8.1: G27 arrives by rapid)
G90 G00 X5.
G27 X0 (expect moves: rapid X0)
M30
