O1 (PS1137: THEN with a word behind it)
IF[1EQ1]THEN M08 (expect alarm PS1137)
M30
