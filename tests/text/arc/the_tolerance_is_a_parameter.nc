(run with: --param CRE=0.1)
O1 (ARC-7: CRE 0.1 accepts 5.000 and 5.080)
G02 X10.08 Y0 I5. F100 (expect moves: cw X10.08 Y0 @5,0)
M30
