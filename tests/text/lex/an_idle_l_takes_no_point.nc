O1 (LEX-26: a point, wherever L stands)
G00 X1. L1. (expect alarm PS0007 at L1.)
M30
