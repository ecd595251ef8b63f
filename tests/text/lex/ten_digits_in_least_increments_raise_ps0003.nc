O1 (LEX-28: 1234567. mm are 1234567000 increments)
G90 G00 X1234567. (expect alarm PS0003 at X1234567.)
M30
(finally moves: none)
