print mod(-7,3); -7%3; mod(7,-3); 7%-3; mod(5.5,2); 5.5%2
' (finally prints 2 -1 -2 1 1.5 1.5)
