(run with: --block-skip 3)
O1 (LEX-20: /1/3 is skipped by either switch)
/1/3 G00 X1. (expect moves: none)
/1/2 G00 X2. (expect moves: rapid X2)
M30
