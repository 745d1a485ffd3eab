-- A page of docs/: its first heading is its title, links to pages lead to their HTML.
local function to_html(target)
  if target:match("^%a+:") then return target end
  return (target:gsub("%.md$", ".html"):gsub("%.md#", ".html#"))
end

function Link(link)
  link.target = to_html(link.target)
  return link
end

function Pandoc(page)
  for _, block in ipairs(page.blocks) do
    if block.t == "Header" and block.level == 1 then
      page.meta.pagetitle = pandoc.utils.stringify(block)
      break
    end
  end
  return page
end
