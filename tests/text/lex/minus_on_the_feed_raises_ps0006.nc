O1 (LEX-27: F takes no sign)
G01 X1. F-100. (expect alarm PS0006 at F-100.)
M30
(finally moves: none)
