O1 (X-0. is 0, so is I-0.)
G90 G0 X1.
X-0. (expect moves: rapid X0)
#100=#5001 (expect #100=0)
G2 X10. Y-0. I5. J-0. F100 (expect moves: cw X10 Y0 @5,0)
M30
