O1 (LEX-4, LEX-5: execution does not run on into the next program)
G90 G00 X1. (expect moves: rapid X1)
O2
#100=1
M30
(finally alarm PS5010)
(finally #100=null)
