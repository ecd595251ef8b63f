O1 (PS1095: eleven K)
G65 P2 K1. K1. K1. K1. K1. K1. K1. K1. K1. K1. K1. (expect alarm PS1095)
M30
O2
M99
