O1 (LEX-13: comments do not nest, the rest is program text)
(A(B) G00 X1. (expect moves: rapid X1)
M30
