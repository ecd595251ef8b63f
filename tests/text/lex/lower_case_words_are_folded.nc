O1 (LEX-10: g0 x1. is G0 X1.)
g0 x1. (expect moves: rapid X1)
#1=5 
x#1 (expect moves: rapid X5)
m30
