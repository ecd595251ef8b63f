O1 (M99-4: X5. M99 moves, then returns)
M98 P2
#100=#5001 (expect #100=5)
M30
O2
G90 G00 X5. M99 (expect moves: rapid X5)
