(run with: --machine mill4)
O1 (NUM-3: A90000 is 90 degrees)
G90 G00 A90000 (expect moves: rapid A90)
A45. (expect moves: rapid A45)
M30
