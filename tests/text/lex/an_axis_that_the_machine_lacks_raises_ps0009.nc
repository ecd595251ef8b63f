O1 (LEX-32: mill3 has no A axis)
G00 X1. A10. (expect alarm PS0009 at A10.)
M30
(finally moves: none)
