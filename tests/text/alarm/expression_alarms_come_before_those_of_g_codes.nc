O1 (section 13: a division by 0 in the block of an unknown G code)
G777 X[1/0] (expect alarm PS0112)
M30
