O1 (G-1: G28 is one-shot)
G90 G01 X5. F100
G28 X5.
X7. (expect moves: line X7)
M30
