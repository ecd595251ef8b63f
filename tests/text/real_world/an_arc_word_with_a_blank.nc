O1 (I 0. with the blank inside)
G2 X 10. Y 0. I 5. J 0. F 100. (expect moves: cw X10 Y0 @5,0 F100)
M30
