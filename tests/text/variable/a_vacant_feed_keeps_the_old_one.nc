O1 (VAR-7: F#1 with #1 vacant changes nothing)
G01 X1. F100
X2. F#1 (expect moves: line X2 F100)
M30
