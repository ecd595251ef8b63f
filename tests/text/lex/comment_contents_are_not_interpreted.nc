%
O1 (LEX-13: separators and brackets inside a comment are text)
G00(A;B/C%D[E#F)X1. (expect moves: rapid X1)
#100=5(;#100=6) (expect #100=5)
M30
%
