(run with: --machine mill4)
O1 (LEX-32: mill4 has an A axis)
G90 G00 X1. A10. (expect moves: rapid X1 A10)
M30
