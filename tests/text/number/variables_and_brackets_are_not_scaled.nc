O1 (NUM-13: X5 is 5 thousandths, but #1 and [5] are 5 mm)
#1=5
G90 G00 X#1 Y[5] Z5 (expect moves: rapid X5 Y5 Z0.005)
M30
