O1 (section 13: no feed in the block of an unknown G code)
G01 G777 X1. (expect alarm PS0010)
M30
