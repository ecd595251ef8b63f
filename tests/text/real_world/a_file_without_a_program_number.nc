#100=1 (a file that starts with its first block) (expect #100=1)
G90 G0 X1. (expect moves: rapid X1)
M30
