O1 (LEX-24: .5, 5., -.5 and a plus sign are numbers)
G90 G00 X.5 (expect moves: rapid X0.5)
X5. (expect moves: rapid X5)
X-.5 (expect moves: rapid X-0.5)
X+5. (expect moves: rapid X5)
M30
