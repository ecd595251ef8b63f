(run with: --block-skip 1)
O1 (LEX-18: slash is slash 1)
/G00 X1. (expect moves: none)
/1 G00 Y1. (expect moves: none)
/2 G00 X3. (expect moves: rapid X3 Y0)
M30
