O1 (LEX-9: G 0 0 X 1 0 . is G00 X10.)
G 0 0 X 1 0 . (expect moves: rapid X10)
# 1 0 0 = 5 (expect #100=5)
# 1 0 1 = # 1 0 0 * [ 2 + 1 ] (expect #101=15)
M30
