O1 (,C: both sides lose 1 mm)
G90 G01 X10. F100 ,C1. (expect moves: line X9 Y0; line X10 Y1)
Y10. (expect moves: line X10 Y10)
M30
