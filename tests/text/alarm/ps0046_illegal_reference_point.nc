O1 (PS0046: there are four reference points)
G91 G30 P9 X0 (expect alarm PS0046 at P9)
M30
